/** Measures guards that nest deeply. */
package arcomat.benchmarks.guards;
