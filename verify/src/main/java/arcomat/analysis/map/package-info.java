/**
 * Refinement between components with different ports: a map says how the ports of the one stand for
 * those of the other; both are put behind and before it, so that they have the same ports, and what
 * is then asked is the ordinary question.
 */
package arcomat.analysis.map;
