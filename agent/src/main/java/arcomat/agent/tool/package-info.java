/** One tool, one class: what it is told, what it asks the pipeline for, which record it answers. */
package arcomat.agent.tool;
