package arcomat.benchmarks.data;

import arcomat.benchmarks.data.DataQuestion.Row;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** The families of questions. */
final class DataQuestions {
    private static final int[] PRIMES = {1_000_003, 1_000_033, 1_000_037, 1_000_039, 1_000_081};

    private DataQuestions() {}

    /** {@code gaps 20}. */
    static DataQuestion of(String label) {
        String[] words = label.strip().split(" ");
        int size = Integer.parseInt(words[1]);
        return switch (words[0]) {
            case "gaps" -> question("gaps", size, 0, DataQuestions::gap);
            case "remainders" -> question("remainders", size, 0, i -> remainder(i, size));
            case "squares" -> question("squares", size, 0, DataQuestions::square);
            case "factors" -> question("factors", size, 0, DataQuestions::factor);
            case "chain" -> chain(size);
            default -> throw new IllegalArgumentException(label);
        };
    }

    private interface Rows {
        Row at(int i);
    }

    private static DataQuestion question(String name, int size, int parts, Rows rows) {
        List<Row> all = new ArrayList<>();
        IntStream.range(0, size).forEach(i -> all.add(rows.at(i)));
        return new DataQuestion(name, size, parts, all);
    }

    /** A part after the other adds 3, and so does the right side at once. */
    private static DataQuestion chain(int parts) {
        int sum = 3 * parts;
        Row row =
                new Row(
                        "p > q",
                        "!(q >= p + " + sum + ")",
                        "(bvsgt (bvadd p " + vector(sum) + ") q)",
                        "(not (bvsge q (bvadd p " + vector(sum) + ")))");
        return new DataQuestion("chain", parts, parts, List.of(row));
    }

    /** Ranges of a difference, which wraps around. */
    private static Row gap(int i) {
        int low = 10 * i;
        int high = low + 10;
        return new Row(
                "p - q > %d && p - q <= %d".formatted(low, high),
                "!(p - q <= %d) && !(%d < p - q)".formatted(low, high),
                "(and (bvsgt (bvsub p q) %s) (bvsle (bvsub p q) %s))"
                        .formatted(vector(low), vector(high)),
                "(and (not (bvsle (bvsub p q) %s)) (not (bvslt %s (bvsub p q))))"
                        .formatted(vector(low), vector(high)));
    }

    private static Row remainder(int i, int size) {
        return new Row(
                "p %% %d == %d".formatted(size, i),
                "!(p %% %d != %d)".formatted(size, i),
                "(= (bvsrem p %s) %s)".formatted(vector(size), vector(i)),
                "(not (distinct (bvsrem p %s) %s))".formatted(vector(size), vector(i)));
    }

    /** Where nothing wraps around, there is one square root below 0, and one above. */
    private static Row square(int i) {
        int root = 7 + i;
        String small = "(and (bvslt p " + vector(40_000) + ") (bvsgt p " + vector(-40_000) + "))";
        return new Row(
                "p < 40000 && p > -40000 && p * p == " + root * root,
                "p == %d || p == -%d".formatted(root, root),
                "(and %s (= (bvmul p p) %s))".formatted(small, vector(root * root)),
                "(or (= p %s) (= p %s))".formatted(vector(root), vector(-root)));
    }

    /** Primes have no factors; the right side knows that. */
    private static Row factor(int i) {
        int prime = PRIMES[i];
        String small =
                "(bvsgt p #x00000001) (bvslt p %s) (bvsgt q #x00000001) (bvslt q %s)"
                        .formatted(vector(40_000), vector(40_000));
        return new Row(
                "p > 1 && p < 40000 && q > 1 && q < 40000 && p * q == " + prime,
                "p > q && p < q",
                "(and %s (= (bvmul p q) %s))".formatted(small, vector(prime)),
                "false");
    }

    private static String vector(int value) {
        return "#x%08x".formatted(value);
    }
}
