/**
 * What the names of the trees stand for: components, ports, instances, types, automata and the
 * types of expressions, computed on demand and never changed. It reports nothing: whatever does not
 * resolve is data that the checks word. It knows neither the checks nor what a model means.
 */
package arcomat.symbols;
