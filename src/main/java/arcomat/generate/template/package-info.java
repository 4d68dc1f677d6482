/** Filling templates in: the only place that knows FreeMarker, and what may go wrong in it. */
package arcomat.generate.template;
