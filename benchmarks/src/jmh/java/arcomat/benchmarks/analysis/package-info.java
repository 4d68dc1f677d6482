/** How long the formal analyses take, warm and cold, and beside MONA. */
package arcomat.benchmarks.analysis;
