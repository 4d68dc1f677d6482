/** New model roots: what lies in the folder of somebody who begins. Knows no model. */
package arcomat.generate.project;
