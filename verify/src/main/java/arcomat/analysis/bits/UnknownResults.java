package arcomat.analysis.bits;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Results of operations that have no circuit: texts that are put together, and remainders of
 * numbers of floating point, which would take a step for each bit of a quotient of two thousand. Of
 * these it is only known that the same of the same gives the same (uninterpreted functions:
 * Ackermann, "Solvable Cases of the Decision Problem", 1954).
 */
final class UnknownResults {
    /** The same bits of the same types stand for the same values. */
    private record Operation(
            BinaryOperator operator, Type left, Type right, List<Integer> operands) {}

    /** An operation, and what has been taken for its result. */
    record Result(Expression.Binary operation, int[] bits) {}

    private final Map<Operation, Result> results = new LinkedHashMap<>();

    static boolean isOf(Expression.Binary binary) {
        return switch (binary.operator()) {
            case PLUS -> binary.type() instanceof Type.StringType;
            case REMAINDER -> binary.type() instanceof Type.RealType;
            default -> false;
        };
    }

    /**
     * The bits of a result.
     *
     * @param any bits that stand for nothing else
     */
    int[] bits(Expression.Binary operation, int[] left, int[] right, Supplier<int[]> any) {
        List<Integer> operands =
                IntStream.concat(Arrays.stream(left), Arrays.stream(right)).boxed().toList();
        Operation key =
                new Operation(
                        operation.operator(),
                        operation.left().type(),
                        operation.right().type(),
                        operands);
        return results.computeIfAbsent(key, each -> new Result(operation, any.get())).bits();
    }

    /** What operands are made of comes before them. */
    List<Result> all() {
        return List.copyOf(results.values());
    }
}
