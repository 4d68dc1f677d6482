/** What guards cost that nest deeply. */
package arcomat.benchmarks.guards;
