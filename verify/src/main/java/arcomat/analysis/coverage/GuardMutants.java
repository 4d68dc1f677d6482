package arcomat.analysis.coverage;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Guards with one small mistake: an operator that looks much the same, a number beside. */
record GuardMutants(Expression guard) {
    private static final Map<BinaryOperator, BinaryOperator> TAKEN_FOR =
            Map.of(
                    BinaryOperator.LESS, BinaryOperator.LESS_OR_EQUAL,
                    BinaryOperator.LESS_OR_EQUAL, BinaryOperator.LESS,
                    BinaryOperator.GREATER, BinaryOperator.GREATER_OR_EQUAL,
                    BinaryOperator.GREATER_OR_EQUAL, BinaryOperator.GREATER,
                    BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL,
                    BinaryOperator.NOT_EQUAL, BinaryOperator.EQUAL,
                    BinaryOperator.AND, BinaryOperator.OR,
                    BinaryOperator.OR, BinaryOperator.AND);

    /**
     * A guard with a mistake.
     *
     * @param what the mistake in words, the same for like mistakes in several places
     */
    record Changed(String what, Expression guard) {}

    List<Changed> all() {
        List<Expression> places = new ArrayList<>();
        guard.visit(places::add);
        List<Changed> mutants = new ArrayList<>();
        for (int place = 0; place < places.size(); place++) {
            int chosen = place;
            Expression right = places.get(place);
            mistake(right).ifPresent(wrong -> mutants.add(changed(chosen, right, wrong)));
        }
        return mutants;
    }

    private Changed changed(int place, Expression right, Expression wrong) {
        String what = "has " + sign(wrong) + " for " + sign(right) + " in its guard";
        return new Changed(what, replaced(place, wrong));
    }

    private static String sign(Expression e) {
        return e instanceof Expression.Binary binary
                ? binary.operator().sign()
                : ((Expression.Constant) e).value().toString();
    }

    private static Optional<Expression> mistake(Expression e) {
        if (e instanceof Expression.Binary binary && TAKEN_FOR.containsKey(binary.operator())) {
            return Optional.of(
                    new Expression.Binary(
                            TAKEN_FOR.get(binary.operator()),
                            binary.left(),
                            binary.right(),
                            binary.type(),
                            binary.span()));
        }
        if (e instanceof Expression.Constant constant
                && constant.type() instanceof Type.IntegerType type
                && constant.value() instanceof Value.IntegerValue number
                && number.value() < type.high()) {
            Value beside = new Value.IntegerValue(number.value() + 1);
            return Optional.of(new Expression.Constant(beside, type, constant.span()));
        }
        return Optional.empty();
    }

    /** The guard with another expression at a place, counted as they are visited. */
    private Expression replaced(int place, Expression instead) {
        int[] count = {0};
        return guard.rewritten(e -> count[0]++ == place ? instead : e);
    }
}
