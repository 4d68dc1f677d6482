package arcomat.syntax.layout;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/** One element, or one comment, before it is broken into lines that fit. */
final class Line {
    /**
     * A token or a comment.
     *
     * @param space whether a space stands before it
     * @param breakLevel how deep a line may be broken before it, 0 for the best place; -1 for never
     * @param breakBefore whether a new line must begin with it
     * @param column whether it is a bar between the cells of a table
     */
    record Piece(String text, boolean space, int breakLevel, boolean breakBefore, boolean column) {}

    final int level;
    final boolean blankBefore;
    final List<Piece> pieces = new ArrayList<>();

    /** The table of which this is a row, else null. */
    @Nullable Object table;

    /** A package declaration stands apart from what follows. */
    boolean isPackage;

    /** Imports stand together, apart from what follows. */
    boolean isImport;

    /** Whether the line ends with the brace that opens a body. */
    boolean opensBody;

    /** Whether the line begins with the brace that closes a body. */
    boolean closesBody;

    Line(int level, boolean blankBefore) {
        this.level = level;
        this.blankBefore = blankBefore;
    }
}
