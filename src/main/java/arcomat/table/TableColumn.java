package arcomat.table;

import arcomat.source.Span;

/**
 * A column of a table.
 *
 * @param isPort whether the component has such a port, of the side on which the column stands; what
 *     stands below one that is none is not looked at
 */
record TableColumn(Span place, boolean isPort) {}
