"""Add-ons: what neither of the two papers needs. Found by name (`toolkit.registry`)."""

from toolkit.registry import modules, register

__getattr__, __dir__, __all__ = modules(__name__, __path__)

_HERE = "toolkit.extra"
for _name, _part in {
    "reader.glb": "formats.gltf:read", "reader.gltf": "formats.gltf:read",
    "reader.vrm": "formats.gltf:read", "reader.vrma": "formats.gltf:read",
    "reader.fbx": "formats.fbx:read",
    "reader.npz": "formats.npz:read", "reader.npy": "formats.npz:read",
    "recording.interpretation": "formats.interpretation",
    "recording.inspection": "formats.inspection:inspect",
    "writer.glb": "engines.character_gltf:write", "writer.npz": "engines.amass:write",
    "writer.usdc": "engines.usd:write",
    "character.load": "characters.character:Character",
    "toolkit.runtime.compile": "compiled:CompiledModel",
    "toolkit.runtime.compiled": "compiled", "toolkit.runtime.quick": "compiled:quick",
    "toolkit.view.Director": "shots.director:Director", "toolkit.view.director": "shots.director",
    "toolkit.features.store": "store", "toolkit.motion.retargeting": "characters.retargeting",
    "crowd.places": "shots.crowd:places",
}.items():
    register(_name, f"{_HERE}.{_part}")
