package arcomat.source;

/** A place for people: line and column, both from 1. */
public record Position(int line, int column) {
    @Override
    public String toString() {
        return line + ":" + column;
    }
}
