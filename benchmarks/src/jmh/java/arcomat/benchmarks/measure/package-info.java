/** What a measurement is: a group of them, its figures, and the aim that they are held against. */
package arcomat.benchmarks.measure;
