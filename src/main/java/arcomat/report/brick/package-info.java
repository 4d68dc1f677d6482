/** What is known of a robot's jar, and runs of it on a simulated brick. Knows nothing of models. */
package arcomat.report.brick;
