/** The views of components and message types: from plans to records of ready-made text. */
package arcomat.generate.views;
