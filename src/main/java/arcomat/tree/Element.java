package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** What stands in the body of a component. */
public sealed interface Element extends Node
        permits Component,
                Behaviour,
                Element.Ports,
                Element.Subcomponent,
                Element.Connector,
                Element.Timing,
                Element.Autoconnect,
                Element.Autoinstantiate,
                Element.Invariant,
                Element.Variables,
                Element.Start,
                Element.JavaPart,
                Element.Features,
                Element.Constraint,
                Element.Variation {
    /** Takes the sum apart: one step for each form, and the compiler asks for all of them. */
    void accept(Visitor visitor);

    /** One step for each form. */
    interface Visitor {
        void component(Component component);

        void behaviour(Behaviour behaviour);

        void ports(Ports ports);

        void subcomponent(Subcomponent subcomponent);

        void connector(Connector connector);

        void timing(Timing timing);

        void autoconnect(Autoconnect clause);

        void autoinstantiate(Autoinstantiate clause);

        void invariant(Invariant invariant);

        void variables(Variables variables);

        void start(Start start);

        void javaPart(JavaPart part);

        void features(Features features);

        void constraint(Constraint constraint);

        void variation(Variation variation);
    }

    /** {@code port in A a, out B b;}. */
    record Ports(Span span, List<Stereotype> stereotypes, List<Port> ports) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.ports(this);
        }
    }

    /**
     * One declaration of a port list. It may name several ports, or none: then the port is named
     * like its type with a lower-case first letter.
     */
    record Port(
            Span span,
            List<Stereotype> stereotypes,
            Direction direction,
            TypeReference type,
            List<Name> names)
            implements Node {}

    enum Direction {
        IN,
        OUT
    }

    /**
     * {@code component Type(args) a, b;}; without instances there is one under an implicit name.
     */
    record Subcomponent(
            Span span,
            List<Stereotype> stereotypes,
            TypeReference type,
            List<Argument> arguments,
            List<Instance> instances)
            implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.subcomponent(this);
        }
    }

    record Instance(Span span, Name name, List<SimpleConnector> connectors) implements Node {}

    /**
     * {@code a -> b.c} inside the brackets of an instance; the source is a port of the instance.
     */
    record SimpleConnector(
            Span span,
            List<Stereotype> stereotypes,
            QualifiedName source,
            List<QualifiedName> targets)
            implements Node {}

    record Connector(
            Span span,
            List<Stereotype> stereotypes,
            QualifiedName source,
            List<QualifiedName> targets)
            implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.connector(this);
        }
    }

    record Timing(Span span, List<Stereotype> stereotypes, TimingKind kind) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.timing(this);
        }
    }

    /** The words of the language; what they mean is decided in the room of symbols. */
    enum TimingKind {
        INSTANT,
        DELAYED,
        UNTIMED,
        CAUSALSYNC,
        SYNC,
        TIMED
    }

    record Autoconnect(Span span, List<Stereotype> stereotypes, AutoconnectKind kind)
            implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.autoconnect(this);
        }
    }

    enum AutoconnectKind {
        TYPE,
        PORT,
        OFF
    }

    record Autoinstantiate(Span span, List<Stereotype> stereotypes, boolean on) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.autoinstantiate(this);
        }
    }

    /**
     * A condition that always holds, in words of some language.
     *
     * @param text as it is written
     * @param condition the text as an expression; empty where it is none
     */
    record Invariant(
            Span span, Optional<Name> kind, Name name, String text, Optional<Expression> condition)
            implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.invariant(this);
        }
    }

    record Variables(Span span, TypeReference type, List<Variable> variables) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.variables(this);
        }
    }

    /** {@code init {..}}: done before the first slice, by the {@code compute} beside it. */
    record Start(Span span, Optional<Name> name, Statement.Sequence statements) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.start(this);
        }
    }

    /**
     * {@code compute {..}} or {@code init {..}} of 2017 models: Java, kept and reported.
     *
     * @param first what is no statement, for it is Java, or a mistake, without spaces; empty where
     *     the statements beside it decide
     */
    record JavaPart(
            Span span, String keyword, Optional<Name> name, String text, Optional<Name> first)
            implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.javaPart(this);
        }
    }

    /** {@code feature f, g;}: what an instance of the component chooses, or leaves out. */
    record Features(Span span, List<Name> names) implements Element {
        public Features {
            names = List.copyOf(names);
        }

        @Override
        public void accept(Visitor visitor) {
            visitor.features(this);
        }
    }

    /** {@code constraint (f implies g);}: what is true of the features that are chosen together. */
    record Constraint(Span span, Expression condition) implements Element {
        @Override
        public void accept(Visitor visitor) {
            visitor.constraint(this);
        }
    }

    /**
     * {@code varif (f) {..} else {..}}: elements that only some configurations have.
     *
     * @param otherwise what the others have in their place; another {@code varif} is one element
     */
    record Variation(Span span, Expression condition, List<Element> then, List<Element> otherwise)
            implements Element {
        public Variation {
            then = List.copyOf(then);
            otherwise = List.copyOf(otherwise);
        }

        @Override
        public void accept(Visitor visitor) {
            visitor.variation(this);
        }
    }
}
