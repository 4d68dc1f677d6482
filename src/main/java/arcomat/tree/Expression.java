package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** An expression of guards, items, initial values and arguments. Parentheses leave no node. */
public sealed interface Expression extends Node {

    /** A literal as written, quotes and suffixes included. */
    record Literal(Span span, Kind kind, String text) implements Expression {
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
    }

    /** {@code a}, {@code a.b}, {@code Enum.CONSTANT}: what it is, resolution tells. */
    record Reference(Span span, QualifiedName name) implements Expression {}

    record Unary(Span span, UnaryOperator operator, Expression operand) implements Expression {}

    record Binary(Span span, BinaryOperator operator, Expression left, Expression right)
            implements Expression {}

    /** {@code c ? a : b} and {@code if c then a else b}. */
    record Conditional(Span span, Expression condition, Expression then, Expression otherwise)
            implements Expression {}

    /** {@code a isin {b, c}}. */
    record Membership(Span span, Expression element, List<Expression> set) implements Expression {
        public Membership {
            set = List.copyOf(set);
        }
    }

    /** {@code a == --} and, with {@code present}, {@code a != --}. */
    record Absence(Span span, Expression operand, boolean present) implements Expression {}

    record Cast(Span span, TypeReference type, Expression operand) implements Expression {}

    record InstanceOf(Span span, Expression operand, TypeReference type) implements Expression {}

    /** {@code f(a)} or {@code x.f(a)}: parsed to be reported as unsupported. */
    record Call(Span span, Optional<Expression> target, Name name, List<Expression> arguments)
            implements Expression {
        public Call {
            arguments = List.copyOf(arguments);
        }
    }

    /**
     * {@code new T(a)}, {@code x[i]}, {@code f(a).b}: Java expressions, reported as unsupported.
     */
    record JavaExpression(Span span, String text) implements Expression {}

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
    }
}
