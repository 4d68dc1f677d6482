/** Checking a project again after a change of one file, beside checking all of it. */
package arcomat.benchmarks.incremental;
