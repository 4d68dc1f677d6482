package arcomat.symbols.names;

import arcomat.tree.Expression.Literal;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;

/** The values of literals, by the rules of Java. */
public final class LiteralValues {
    /** Half of the smallest float: less is zero. */
    private static final double LOST_AS_FLOAT = Float.MIN_VALUE / 2.0;

    private LiteralValues() {}

    /**
     * The value of an integer literal.
     *
     * @param negated whether a minus stands before it; the result carries the sign
     * @return empty for other literals and beyond 64 bits
     */
    public static OptionalLong wholeNumber(Literal literal, boolean negated) {
        if (literal.kind() != Literal.Kind.INT && literal.kind() != Literal.Kind.LONG) {
            return OptionalLong.empty();
        }
        if (isShortDecimal(literal.text())) {
            long value = Long.parseLong(literal.text());
            return OptionalLong.of(negated ? -value : value);
        }
        BigInteger magnitude = magnitude(literal.text());
        BigInteger value = negated ? magnitude.negate() : magnitude;
        int bits = literal.kind() == Literal.Kind.INT ? 32 : 64;
        if (!isDecimal(literal.text()) && magnitude.bitLength() == bits) {
            value = magnitude.subtract(BigInteger.ONE.shiftLeft(bits));
            value = negated ? value.negate() : value;
        }
        return value.bitLength() < 64 ? OptionalLong.of(value.longValue()) : OptionalLong.empty();
    }

    /** As nearly all numbers are: a few digits and nothing else. */
    private static boolean isShortDecimal(String text) {
        boolean digits = text.length() < 10 && (text.charAt(0) != '0' || text.length() == 1);
        for (int i = 0; digits && i < text.length(); i++) {
            digits = text.charAt(i) >= '0' && text.charAt(i) <= '9';
        }
        return digits;
    }

    private static boolean isDecimal(String text) {
        return text.charAt(0) != '0'
                || text.length() == 1
                || text.equals("0L")
                || text.equals("0l");
    }

    private static BigInteger magnitude(String text) {
        String digits = text.replace("_", "").toLowerCase(Locale.ROOT);
        if (digits.endsWith("l")) {
            digits = digits.substring(0, digits.length() - 1);
        }
        if (digits.startsWith("0x")) {
            return new BigInteger(digits.substring(2), 16);
        }
        if (digits.startsWith("0b")) {
            return new BigInteger(digits.substring(2), 2);
        }
        boolean octal = digits.length() > 1 && digits.startsWith("0");
        return octal && digits.matches("[0-7]+")
                ? new BigInteger(digits, 8)
                : new BigInteger(digits);
    }

    /** The value of a floating point literal; infinite where it is too large. */
    public static double realNumber(Literal literal) {
        String digits = literal.text().replace("_", "").toLowerCase(Locale.ROOT);
        boolean single = literal.kind() == Literal.Kind.FLOAT;
        if (digits.startsWith("0x")) {
            BigDecimal value = hexadecimal(digits.substring(2));
            return single ? value.floatValue() : value.doubleValue();
        }
        double wide = Double.parseDouble(digits);
        if (!single) {
            return wide;
        }
        // The library of the web page does not round these to zero.
        return wide < LOST_AS_FLOAT ? 0 : Float.parseFloat(digits);
    }

    /**
     * The exact value of a significand and a power of two, {@code 1.8p-2}. It is calculated here
     * since not every library of Java reads it, the one of the web page does not.
     */
    private static BigDecimal hexadecimal(String digits) {
        String[] halves = digits.replaceAll("[fd]$", "").split("p", 2);
        int point = halves[0].indexOf('.');
        int behind = point < 0 ? 0 : halves[0].length() - point - 1;
        BigInteger significand = new BigInteger("0" + halves[0].replace(".", ""), 16);
        int power = exponent(halves[1], halves[0].length()) - 4 * behind;
        return power >= 0
                ? new BigDecimal(significand.shiftLeft(power))
                : new BigDecimal(significand.multiply(BigInteger.valueOf(5).pow(-power)), -power);
    }

    /** An exponent; one that makes any number of so many digits zero or infinite is cut. */
    private static int exponent(String text, int digits) {
        BigInteger most = BigInteger.valueOf(2_000 + 4L * digits);
        return new BigInteger(text.replace("+", "")).min(most).max(most.negate()).intValue();
    }

    /**
     * Whether a number that is not zero was rounded to zero. Java refuses such a literal.
     *
     * @param written a floating point literal
     */
    public static boolean isLost(String written, double value) {
        String lower = written.toLowerCase(Locale.ROOT);
        boolean hexadecimal = lower.contains("x");
        String digits = hexadecimal ? lower.substring(lower.indexOf('x') + 1) : lower;
        String significand = digits.split(hexadecimal ? "p" : "[efd]", 2)[0];
        return value == 0 && significand.matches(".*[1-9a-f].*");
    }

    public static boolean isTrue(Literal literal) {
        return literal.text().equals("true");
    }

    /** The text between the quotes with escapes resolved; empty where an escape is wrong. */
    public static Optional<String> unquoted(Literal literal) {
        String text = literal.text();
        StringBuilder result = new StringBuilder();
        int at = 1;
        while (at < text.length() - 1) {
            char c = text.charAt(at++);
            if (c != '\\') {
                result.append(c);
                continue;
            }
            int taken = escape(text, at, result);
            if (taken == 0) {
                return Optional.empty();
            }
            at += taken;
        }
        return Optional.of(result.toString());
    }

    /** Appends what the escape at a position stands for and tells its length, 0 if it is wrong. */
    private static int escape(String text, int at, StringBuilder result) {
        int simple = "btnfr\"'\\s".indexOf(text.charAt(at));
        if (simple >= 0) {
            result.append("\b\t\n\f\r\"'\\ ".charAt(simple));
            return 1;
        }
        if (text.charAt(at) == 'u') {
            return unicodeEscape(text, at, result);
        }
        int end = at;
        while (end < text.length() - 1
                && end < at + 3
                && "01234567".indexOf(text.charAt(end)) >= 0) {
            end++;
        }
        if (end == at) {
            return 0;
        }
        int code = Integer.parseInt(text.substring(at, end), 8);
        result.append((char) (code & 0xFF));
        return end - at;
    }

    /** As many letters u as there are; then four digits. */
    private static int unicodeEscape(String text, int at, StringBuilder result) {
        int digits = at;
        while (text.charAt(digits) == 'u') {
            digits++;
        }
        int end = digits + 4;
        if (end >= text.length() || !text.substring(digits, end).matches("[0-9a-fA-F]{4}")) {
            return 0;
        }
        result.append((char) Integer.parseInt(text.substring(digits, end), 16));
        return end - at;
    }
}
