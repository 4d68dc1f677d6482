/**
 * What goes on inside of a program for the brick while it runs, told as a run of the model that it
 * was made of. Knows neither worlds nor scripts: who runs the program tells it what happens.
 */
package arcomat.pipeline.inside;
