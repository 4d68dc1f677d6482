package arcomat.syntax.build;

import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.tree.Name;

import org.antlr.v4.runtime.Token;

import java.math.BigInteger;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * The names of the elements of arrays. Each is declared by itself from here on; what is written
 * stands in the text of their place.
 */
final class ArrayBuilder {
    private static final BigInteger BEYOND = BigInteger.valueOf(Integer.MAX_VALUE);

    private ArrayBuilder() {}

    static Name element(Span span, Name array, int index) {
        return new Name(span, ArrayNames.element(array.text(), index));
    }

    /** One at least and not too many; that there are others is told. */
    static List<Name> elements(Span span, Name array, int size) {
        return IntStream.range(0, Math.max(1, Math.min(size, ArrayNames.MOST)))
                .mapToObj(index -> element(span, array, index))
                .toList();
    }

    /** Beyond all reason it stays beyond all reason. */
    static int number(Token token) {
        String digits = token.getText().replace("_", "");
        String prefix = digits.length() > 1 ? digits.substring(0, 2).toLowerCase(Locale.ROOT) : "";
        BigInteger value =
                switch (prefix) {
                    case "0x" -> new BigInteger(digits.substring(2), 16);
                    case "0b" -> new BigInteger(digits.substring(2), 2);
                    default -> new BigInteger(digits);
                };
        return value.min(BEYOND).intValue();
    }
}
