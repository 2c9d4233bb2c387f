// The module of every widget. anywidget waits two seconds for it; if it comes later, on a busy machine, anywidget drops every
// message to the widget. So it is small, and the trait `code`, a module of its own, is loaded when the first such widget is
// drawn, once for a page. If it is too late even so, messages go past anywidget, and what was lost is sent again.
const modules = (globalThis.toolkitModules ??= {});

async function listen(model) {
  const real = await model.widget_manager.get_model(model.get("key"));
  const plain = Object.getPrototypeOf(real.constructor.prototype); // without anywidget
  await real._handle_comm_msg({ content: { data: {} } }).catch(() => {
    real.comm.on_msg((message) => plain._handle_comm_msg.call(real, message));
    real.comm.send({ method: "request_state" }, {});
  });
}

async function render({ model, el }) {
  const code = model.get("code");
  modules[code] ??= import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
  const module = await modules[code];
  await listen(model);
  return module.default.render({ model, el });
}

export default { render };
