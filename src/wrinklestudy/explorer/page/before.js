// Before Plotly: it reads back what it writes on canvases, so they stay where that is fast.
{
  const contextOf = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    const more = kind === "2d" ? { ...options, willReadFrequently: true } : options;
    return contextOf.call(this, kind, more);
  };
}
