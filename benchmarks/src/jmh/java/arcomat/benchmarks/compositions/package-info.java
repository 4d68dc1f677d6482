/**
 * Compositions of many parts, beside Spin: both are given the same system, from one description.
 */
package arcomat.benchmarks.compositions;
