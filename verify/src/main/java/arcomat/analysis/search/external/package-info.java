/**
 * A search whose pairs do not fit into memory: breadth first, with duplicates detected a level
 * later, by sorting what a level has led to and merging it with sorted runs of what has been met
 * (Stern, Dill, "Using magnetic disk instead of main memory in the Murphi verifier", CAV 1998;
 * Korf, "Best-first frontier search with delayed duplicate detection", AAAI 2004). Knows nothing of
 * files: somebody else keeps blocks of numbers.
 */
package arcomat.analysis.search.external;
