/**
 * Directed graphs over numbers: their strongly connected components, shortest cycles, order and
 * reachability, one copy each. Knows nothing of what the numbers stand for.
 */
package arcomat.graph;
