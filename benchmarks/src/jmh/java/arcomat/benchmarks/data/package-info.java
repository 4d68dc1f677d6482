/** Questions about numbers without an end, beside solvers that are asked the same. */
package arcomat.benchmarks.data;
