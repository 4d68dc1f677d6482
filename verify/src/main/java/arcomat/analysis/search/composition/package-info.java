/** One slice, or one event, of a composition unfolded into what all parts may do together. */
package arcomat.analysis.search.composition;
