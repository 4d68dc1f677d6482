/**
 * The door: the command line. Parses arguments, calls the pipeline, prints what it hands out, and
 * turns the outcome into an exit status. Knows no other room but for the results it prints.
 */
package arcomat.cli;
