package arcomat.check.behaviour.action;

import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Expression.BinaryOperator;
import arcomat.tree.Expression.UnaryOperator;

import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/**
 * Which messages an expression reads, and which of them it reads without having asked whether they
 * are there. Names stand for what they hold.
 */
final class MessageReads {
    /**
     * What a name stands for.
     *
     * @param all messages that it was made from
     * @param open those of them that may not be there, unless they count where it was assigned
     * @param unguarded those of them that nothing in it asks for first
     */
    record Held(
            Set<PortSymbol> all,
            Set<PortSymbol> open,
            Set<PortSymbol> unguarded,
            KnownMessages presence) {
        static final Held NOTHING = new Held(Set.of(), Set.of(), Set.of(), KnownMessages.NONE);

        /** The same, where what it reads counts at the place that assigned it. */
        Held counted() {
            return new Held(all, Set.of(), Set.of(), presence);
        }

        /** What is the one or the other, and counts at the places that assigned it. */
        Held either(Held other) {
            return new Held(
                    KnownMessages.all(all, other.all),
                    Set.of(),
                    Set.of(),
                    presence.either(other.presence));
        }
    }

    private final Function<VariableSymbol, Held> held;
    private final Map<TypedExpression, KnownMessages> known = new IdentityHashMap<>();

    /**
     * @param held what names stand for at this place
     */
    MessageReads(Function<VariableSymbol, Held> held) {
        this.held = held;
    }

    /** What the value of the expression tells. */
    KnownMessages presence(TypedExpression expression) {
        KnownMessages before = known.get(expression);
        if (before != null) {
            return before;
        }
        KnownMessages found = findPresence(expression);
        known.put(expression, found);
        return found;
    }

    private KnownMessages findPresence(TypedExpression expression) {
        return expression.match(new Presences());
    }

    private KnownMessages ofBinary(TypedExpression.Binary binary) {
        KnownMessages left = presence(binary.left());
        KnownMessages right = presence(binary.right());
        return switch (binary.node().operator()) {
            case AND -> left.and(right);
            case OR -> left.or(right);
            case IMPLIES -> left.negated().or(right);
            default -> KnownMessages.of(KnownMessages.all(left.always(), right.always()));
        };
    }

    private KnownMessages ofChoice(TypedExpression.Conditional choice) {
        KnownMessages condition = presence(choice.condition());
        KnownMessages branches = presence(choice.then()).either(presence(choice.otherwise()));
        return new KnownMessages(
                KnownMessages.all(condition.always(), branches.always()),
                KnownMessages.all(condition.always(), branches.whenTrue()),
                KnownMessages.all(condition.always(), branches.whenFalse()));
    }

    private Set<PortSymbol> ofAll(List<TypedExpression> parts) {
        Set<PortSymbol> all = new HashSet<>();
        parts.forEach(part -> all.addAll(presence(part).always()));
        return all;
    }

    /** All messages that it reads, by itself or through names. */
    Set<PortSymbol> all(TypedExpression expression) {
        return read(expression, Held::all);
    }

    /**
     * The messages that have to be there for the value of an expression to be kept or sent: all
     * that it reads, whatever it asks for first. In text order.
     *
     * @param there ports that are known to have a message at this place
     */
    Set<PortSymbol> open(TypedExpression expression, Set<PortSymbol> there) {
        Set<PortSymbol> open = read(expression, Held::open);
        open.removeAll(there);
        return open;
    }

    private Set<PortSymbol> read(
            TypedExpression expression, Function<Held, Set<PortSymbol>> ofName) {
        Set<PortSymbol> reads = new LinkedHashSet<>();
        expression.walk(
                part -> {
                    if (part instanceof TypedExpression.PortRead read && maySilence(read.port())) {
                        reads.add(read.port());
                    } else if (part instanceof TypedExpression.VariableRead read) {
                        reads.addAll(ofName.apply(held.apply(read.variable())));
                    }
                });
        return reads;
    }

    /**
     * The messages without which a condition may be undefined, in text order.
     *
     * @param there ports that are known to have a message at this place
     */
    Set<PortSymbol> unguarded(TypedExpression expression, Set<PortSymbol> there) {
        Set<PortSymbol> found = new LinkedHashSet<>();
        collect(expression, there, found);
        return found;
    }

    private void collect(TypedExpression expression, Set<PortSymbol> there, Set<PortSymbol> found) {
        if (expression.parts().isEmpty()) {
            Set<PortSymbol> needed = new LinkedHashSet<>(neededByLeaf(expression));
            needed.removeAll(there);
            found.addAll(needed);
        } else if (expression instanceof TypedExpression.Binary binary) {
            collect(binary, there, found);
        } else {
            collectParts(expression, there, found);
        }
    }

    private Set<PortSymbol> neededByLeaf(TypedExpression leaf) {
        if (leaf instanceof TypedExpression.VariableRead read) {
            return held.apply(read.variable()).unguarded();
        }
        return leaf instanceof TypedExpression.PortRead read && maySilence(read.port())
                ? Set.of(read.port())
                : Set.of();
    }

    private void collectParts(
            TypedExpression expression, Set<PortSymbol> there, Set<PortSymbol> found) {
        if (expression instanceof TypedExpression.Conditional choice) {
            KnownMessages condition = presence(choice.condition());
            collect(choice.condition(), there, found);
            collect(choice.then(), KnownMessages.all(there, condition.whenTrue()), found);
            collect(choice.otherwise(), KnownMessages.all(there, condition.whenFalse()), found);
        } else {
            expression.parts().forEach(part -> collect(part, there, found));
        }
    }

    /** What stands beside a part that decides alone does not count where that part does. */
    private void collect(
            TypedExpression.Binary binary, Set<PortSymbol> there, Set<PortSymbol> found) {
        KnownMessages left = presence(binary.left());
        KnownMessages right = presence(binary.right());
        BinaryOperator operator = binary.node().operator();
        Set<PortSymbol> besideLeft =
                switch (operator) {
                    case AND, IMPLIES -> left.whenTrue();
                    case OR -> left.whenFalse();
                    default -> Set.of();
                };
        Set<PortSymbol> besideRight =
                switch (operator) {
                    case AND -> right.whenTrue();
                    case OR, IMPLIES -> right.whenFalse();
                    default -> Set.of();
                };
        collect(binary.left(), KnownMessages.all(there, besideRight), found);
        collect(binary.right(), KnownMessages.all(there, besideLeft), found);
    }

    private static boolean maySilence(PortSymbol port) {
        return port.isInput() && !port.isTotal() && port.first().isEmpty();
    }

    /** What the value of each form of expression tells. */
    private final class Presences implements TypedExpression.Cases<KnownMessages> {
        private KnownMessages ofParts(TypedExpression expression) {
            return KnownMessages.of(ofAll(expression.parts()));
        }

        @Override
        public KnownMessages literal(TypedExpression.Literal literal) {
            return KnownMessages.NONE;
        }

        @Override
        public KnownMessages constant(TypedExpression.Constant constant) {
            return KnownMessages.NONE;
        }

        @Override
        public KnownMessages portRead(TypedExpression.PortRead read) {
            return maySilence(read.port())
                    ? KnownMessages.of(Set.of(read.port()))
                    : KnownMessages.NONE;
        }

        @Override
        public KnownMessages variableRead(TypedExpression.VariableRead read) {
            return held.apply(read.variable()).presence();
        }

        @Override
        public KnownMessages parameterRead(TypedExpression.ParameterRead read) {
            return KnownMessages.NONE;
        }

        @Override
        public KnownMessages attributeRead(TypedExpression.AttributeRead read) {
            return ofParts(read);
        }

        @Override
        public KnownMessages unary(TypedExpression.Unary unary) {
            KnownMessages operand = presence(unary.operand());
            return unary.node().operator() == UnaryOperator.NOT ? operand.negated() : operand;
        }

        @Override
        public KnownMessages binary(TypedExpression.Binary binary) {
            return ofBinary(binary);
        }

        @Override
        public KnownMessages conditional(TypedExpression.Conditional choice) {
            return ofChoice(choice);
        }

        @Override
        public KnownMessages membership(TypedExpression.Membership membership) {
            return ofParts(membership);
        }

        @Override
        public KnownMessages absence(TypedExpression.Absence absence) {
            KnownMessages there = new KnownMessages(Set.of(), Set.of(absence.port()), Set.of());
            return absence.node().present() ? there : there.negated();
        }

        @Override
        public KnownMessages cast(TypedExpression.Cast cast) {
            return ofParts(cast);
        }

        @Override
        public KnownMessages newObject(TypedExpression.NewObject newObject) {
            return ofParts(newObject);
        }

        @Override
        public KnownMessages erroneous(TypedExpression.Erroneous erroneous) {
            return ofParts(erroneous);
        }
    }
}
