package arcomat.symbols.names;

/**
 * Whole numbers from {@code low} to {@code high}, both included; as written, so the ends may be
 * reversed or beyond the carrier.
 */
public record RangeType(BuiltinType carrier, long low, long high) implements TypeSymbol {
    @Override
    public String text() {
        return carrier + "[" + low + ".." + high + "]";
    }

    @Override
    public TypeSymbol base() {
        return carrier;
    }

    public boolean contains(long value) {
        return low <= value && value <= high;
    }

    @Override
    public String toString() {
        return text();
    }
}
