package arcomat.tree;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** {@code testsuite Name for Component(args) {..}}. */
public record TestSuite(
        Span span,
        Name name,
        QualifiedName component,
        List<Argument> arguments,
        List<Member> members)
        implements Definition {
    @Override
    public <R> R match(Definition.Cases<R> cases) {
        return cases.suite().apply(this);
    }

    public sealed interface Member extends Node {
        /** The Java blocks in it. */
        List<Before> before();
    }

    public record Test(Span span, Name name, List<Streams> streams, List<Before> before)
            implements Member {}

    /** A field of 2012 suites: kept, reported. */
    public record Field(Span span, TypeReference type, List<Variable> variables) implements Member {
        @Override
        public List<Before> before() {
            return List.of();
        }
    }

    /** {@code @Before {..}} of 2012 suites: kept, reported. */
    public record Before(Span span, Name name, String text) implements Member {
        @Override
        public List<Before> before() {
            return List.of(this);
        }
    }

    /** One {@code input}, {@code expect} or {@code events} block. */
    public record Streams(Span span, Kind kind, List<PortStream> streams) implements Node {}

    public enum Kind {
        INPUT,
        EXPECT,
        EVENTS
    }

    public record PortStream(Span span, QualifiedName port, List<StreamElement> elements)
            implements Node {}

    public sealed interface StreamElement extends Node {
        /** Takes the sum apart: one answer for each form. */
        <R> R match(Cases<R> cases);

        /** Elements and those in their repetitions, each once, in text order. */
        static List<StreamElement> written(List<StreamElement> elements) {
            List<StreamElement> all = new ArrayList<>();
            add(elements, all);
            return all;
        }

        private static void add(List<StreamElement> elements, List<StreamElement> all) {
            for (StreamElement each : elements) {
                all.add(each);
                if (each instanceof Repeat repeat) {
                    add(repeat.elements(), all);
                }
            }
        }

        /**
         * One answer for each form.
         *
         * @param <R> what is answered
         */
        record Cases<R>(
                Function<Tick, R> tick, Function<Message, R> message, Function<Repeat, R> repeat) {}
    }

    /** {@code Tk}: the end of a time slice. */
    public record Tick(Span span) implements StreamElement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.tick().apply(this);
        }
    }

    public record Message(Span span, Expression expression) implements StreamElement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.message().apply(this);
        }
    }

    /** {@code n*x} and {@code n*(x, y)}. */
    public record Repeat(Span span, int count, List<StreamElement> elements)
            implements StreamElement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.repeat().apply(this);
        }
    }
}
