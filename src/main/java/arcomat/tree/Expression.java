package arcomat.tree;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** An expression of guards, items, initial values and arguments. Parentheses leave no node. */
public sealed interface Expression extends Node {
    /** What it is directly made of, from left to right. */
    List<Expression> operands();

    /** An expression without operands. */
    sealed interface Leaf extends Expression {
        @Override
        default List<Expression> operands() {
            return List.of();
        }
    }

    private static List<Expression> concatenated(
            Optional<Expression> first, List<Expression> rest) {
        return Stream.concat(first.stream(), rest.stream()).toList();
    }

    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R literal(Literal literal);

        R reference(Reference reference);

        R unary(Unary unary);

        R binary(Binary binary);

        R conditional(Conditional conditional);

        R membership(Membership membership);

        R absence(Absence absence);

        R cast(Cast cast);

        R instanceOf(InstanceOf instanceOf);

        R call(Call call);

        R javaExpression(JavaExpression javaExpression);

        R indexed(Indexed indexed);

        R quantified(Quantified quantified);

        R let(Let let);
    }

    /** A literal as written, quotes and suffixes included. */
    record Literal(Span span, Kind kind, String text) implements Leaf {
        public enum Kind {
            BOOLEAN,
            INT,
            LONG,
            FLOAT,
            DOUBLE,
            CHAR,
            STRING,
            NULL
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.literal(this);
        }
    }

    /** {@code a}, {@code a.b}, {@code Enum.CONSTANT}: what it is, resolution tells. */
    record Reference(Span span, QualifiedName name) implements Leaf {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.reference(this);
        }
    }

    record Unary(Span span, UnaryOperator operator, Expression operand) implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.unary(this);
        }
    }

    record Binary(Span span, BinaryOperator operator, Expression left, Expression right)
            implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(left, right);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.binary(this);
        }
    }

    /** {@code c ? a : b} and {@code if c then a else b}. */
    record Conditional(Span span, Expression condition, Expression then, Expression otherwise)
            implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(condition, then, otherwise);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.conditional(this);
        }
    }

    /** {@code a isin {b, c}}. */
    record Membership(Span span, Expression element, List<Expression> set) implements Expression {
        @Override
        public List<Expression> operands() {
            return concatenated(Optional.of(element), set);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.membership(this);
        }
    }

    /** {@code a == --} and, with {@code present}, {@code a != --}. */
    record Absence(Span span, Expression operand, boolean present) implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.absence(this);
        }
    }

    record Cast(Span span, TypeReference type, Expression operand) implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.cast(this);
        }
    }

    record InstanceOf(Span span, Expression operand, TypeReference type) implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.instanceOf(this);
        }
    }

    /** {@code f(a)} or {@code x.f(a)}: parsed to be reported as unsupported. */
    record Call(Span span, Optional<Expression> target, Name name, List<Expression> arguments)
            implements Expression {
        @Override
        public List<Expression> operands() {
            return concatenated(target, arguments);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.call(this);
        }
    }

    /**
     * {@code new T(a)}, {@code f(a).b}, {@code f(a)[i]}: Java expressions, reported as unsupported.
     */
    record JavaExpression(Span span, String text) implements Leaf {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.javaExpression(this);
        }
    }

    /** {@code a[i]}, {@code a[i].b}: a name in which elements of arrays are numbered. */
    record Indexed(Span span, List<Step> steps) implements Expression {
        public Indexed {
            steps = List.copyOf(steps);
        }

        /**
         * @param index as it is written, for an element of an array
         */
        public record Step(Span span, Name name, Optional<Expression> index) implements Node {}

        @Override
        public List<Expression> operands() {
            return steps.stream().map(Step::index).flatMap(Optional::stream).toList();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.indexed(this);
        }
    }

    /**
     * {@code forall x in {a, b}: c}, {@code exists x in Type: c}.
     *
     * @param all whether it is about all of them, or about one at least
     */
    record Quantified(Span span, boolean all, Name name, Domain domain, Expression body)
            implements Expression {
        @Override
        public List<Expression> operands() {
            List<Expression> operands = new ArrayList<>();
            for (Member member : domain.members()) {
                operands.add(member.low());
                member.high().ifPresent(operands::add);
            }
            operands.add(body);
            return operands;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.quantified(this);
        }
    }

    /**
     * What a quantifier is about.
     *
     * @param named an array or a type; empty where the members are written
     */
    record Domain(Span span, Optional<TypeReference> named, List<Member> members) implements Node {
        public Domain {
            members = List.copyOf(members);
        }
    }

    /** {@code low}, or {@code low .. high}. */
    record Member(Span span, Expression low, Optional<Expression> high) implements Node {}

    /** {@code let x = value in body}. */
    record Let(Span span, Name name, Expression value, Expression body) implements Expression {
        @Override
        public List<Expression> operands() {
            return List.of(value, body);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.let(this);
        }
    }

    enum UnaryOperator {
        NOT("!"),
        MINUS("-"),
        PLUS("+"),
        COMPLEMENT("~");

        private final String symbol;

        UnaryOperator(String symbol) {
            this.symbol = symbol;
        }

        public String symbol() {
            return symbol;
        }
    }

    enum BinaryOperator {
        MULTIPLY("*"),
        DIVIDE("/"),
        REMAINDER("%"),
        ADD("+"),
        SUBTRACT("-"),
        LESS("<"),
        LESS_OR_EQUAL("<="),
        GREATER(">"),
        GREATER_OR_EQUAL(">="),
        EQUAL("=="),
        NOT_EQUAL("!="),
        AND("&&"),
        OR("||"),
        IMPLIES("implies"),
        EQUIVALENT("<=>");

        private final String symbol;

        BinaryOperator(String symbol) {
            this.symbol = symbol;
        }

        public String symbol() {
            return symbol;
        }

        /** Whether there is no result where the right operand is zero. */
        public boolean divides() {
            return this == DIVIDE || this == REMAINDER;
        }
    }
}
