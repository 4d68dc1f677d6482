/** Laws about statements in actions. */
package arcomat.check.behaviour.action;
