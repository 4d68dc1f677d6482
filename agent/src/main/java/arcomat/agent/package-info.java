/**
 * Tools for programs that write models and ask about them: the Model Context Protocol, spoken on
 * two streams. What it answers is what the commands print for programs, by the same writers; nobody
 * but the command that starts it knows this room.
 */
package arcomat.agent;
