/**
 * What all commands have in common; a folder each for those about models as texts, about runs,
 * about proofs and about code. A command is one class: its words, and what it asks the pipeline
 * for. It knows how its results are shown and nothing of how they are made.
 */
package arcomat.cli.command;
