"""A live link to Blender: a character of the toolkit moves an armature there, 60 times a second.

In Blender 4, open this file in the text editor and press Run. Then, on the same machine, start a
walk on a circle, until Ctrl-C: ``python examples/blender_link.py Old``. Or, in a notebook, import
this file, and write ``blender_link.stream(controller, model)`` in the cell of a `Controller`. An
armature appears in Blender; while auto keying is on (the red button), a packet is a keyframe.
Packets are UDP: once a second names, parents and offsets of the joints, else the root's place in
metres, y up, and the local quaternions, as numbers of 32 bits.
"""

import asyncio
import itertools
import json
import math
import select
import socket
import sys
import time

try:  # in Blender
    import bpy
    from mathutils import Quaternion, Vector
except ImportError:  # in the toolkit
    import toolkit as tk

    bpy = None
PORT, RATE = ("127.0.0.1", 47100), 60


def sender(model):
    """A function that sends the pose of a state."""
    count, bones = itertools.count(), model.layout.skeleton
    joints = [*zip(bones.names, bones.parents, bones.offsets.tolist(), strict=True)]

    def send(state):
        rotations, root = tk.runtime.pose(model, state)
        with socket.socket(type=socket.SOCK_DGRAM) as plug:
            if next(count) % RATE == 0:
                plug.sendto(json.dumps(joints).encode(), PORT)
            plug.sendto(root[0].numpy().tobytes() + rotations[0].numpy().tobytes(), PORT)

    return send


def stream(controller, model):
    """Send the poses of a Controller until it is closed, by a task that can be cancelled."""
    async def run():
        send = sender(model)
        while controller.state is not None:
            send(controller.state)
            await asyncio.sleep(1 / RATE)

    return asyncio.get_running_loop().create_task(run())


def walk(style="Neutral", seconds=3600.0):
    """Send a walk on a circle, at 1 m/s, in a style of the embedded model."""
    (model, bank), begin = tk.pretrained(), time.monotonic()
    ways = [(math.sin(t / 100), math.cos(t / 100)) for t in range(round(seconds * RATE))]
    commands, send = [*map(tk.runtime.Command, ways, ways)], sender(model)
    for number, state in enumerate(tk.runtime.states(model, commands, bank[style]), 1):
        send(state)
        time.sleep(max(0.0, begin + number / RATE - time.monotonic()))


def armature(joints):
    """An armature of joints (name, parent, offset), whose object turns y up into z up."""
    data, places = bpy.data.armatures.new("toolkit"), []
    thing = bpy.data.objects.new("toolkit", data)
    thing.rotation_euler = (math.pi / 2, 0, 0)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    for number, (name, parent, offset) in enumerate(joints):
        places.append(Vector(offset) + (places[parent] if parent >= 0 else Vector()))
        along = sum((Vector(one[2]) for one in joints if one[1] == number), Vector())
        bone = data.edit_bones.new(name)
        along = along if along.length > 0.01 else Vector((0, 0.05, 0))
        bone.head, bone.tail = places[-1], places[-1] + along
        if parent >= 0:
            bone.parent = data.edit_bones[joints[parent][0]]
    bpy.ops.object.mode_set(mode="OBJECT")
    return thing


def pose(thing, joints, numbers):
    """Put a pose on the armature; its bones have axes of their own, the joints do not."""
    for number, (name, parent, offset) in enumerate(joints):
        bone, turn = thing.pose.bones[name], Quaternion(numbers[3 + 4 * number : 7 + 4 * number])
        axes = bone.bone.matrix_local.to_quaternion()
        bone.rotation_quaternion = axes.inverted() @ turn @ axes
        if parent < 0:
            bone.location = axes.inverted() @ (Vector(numbers[:3]) - Vector(offset))
        if bpy.context.scene.tool_settings.use_keyframe_insert_auto:
            bone.keyframe_insert("rotation_quaternion")
            bone.keyframe_insert("location")


def listen():
    """A function for Blender's timer: it reads all packets, and shows the last pose."""
    plug, shown = socket.socket(type=socket.SOCK_DGRAM), {}
    plug.bind(PORT)

    def read():
        while select.select([plug], [], [], 0.0)[0]:
            packet = plug.recv(65536)
            if not packet.startswith(b'[["'):
                shown["numbers"] = memoryview(packet).cast("f").tolist()
            elif shown.get("joints") != (joints := json.loads(packet)):
                shown.update(joints=joints, thing=armature(joints))
        if len(shown) == 3:
            pose(**shown)
            del shown["numbers"]
        return 1 / RATE

    return read


if __name__ == "__main__":
    bpy.app.timers.register(listen()) if bpy else walk(*sys.argv[1:2])
