// Names that come from outside the modules, and freedom with the elements of the page, whose kinds the markup tells.
declare const uPlot: any;
interface EventTarget { [name: string]: any }
interface Window { steward: any }
