/**
 * One class a command: its words, and what it asks the pipeline for. A command knows how its
 * results are shown and nothing of how they are made.
 */
package arcomat.cli.command;
