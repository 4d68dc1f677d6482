package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.source.Span;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** A trace for programs. Messages are lists, for an event may send several. */
public final class TraceJson implements RunText {
    private final Consumer<String> out;
    private final boolean whyNot;
    private final Json.Growing text = new Json.Growing();

    /**
     * @param out takes the text, step by step
     * @param whyNot whether it names the nearest transition where none was enabled
     */
    public TraceJson(Consumer<String> out, boolean whyNot) {
        this.out = out;
        this.whyNot = whyNot;
    }

    private record Step(
            int number,
            Map<String, List<Object>> inputs,
            Map<String, List<Object>> outputs,
            List<Activity> activities) {
        static Step of(Trace.Step step, boolean whyNot) {
            return new Step(
                    step.number(),
                    MessageJson.all(step.inputs()),
                    MessageJson.all(step.outputs()),
                    step.activities().stream().map(each -> Activity.of(each, whyNot)).toList());
        }
    }

    /** What an automaton did, by the transition at a place or by a completion. */
    private record Activity(
            String instance,
            String automaton,
            String before,
            String after,
            Optional<Integer> transition,
            Optional<String> file,
            Optional<Integer> line,
            Optional<String> completion,
            Map<String, Object> variables,
            Optional<WhyNot> whyNot) {
        static Activity of(Trace.Activity activity, boolean whyNot) {
            Optional<Trace.Taken> taken = as(Trace.Taken.class, activity.cause());
            Optional<Span> place = taken.map(each -> each.transition().span());
            Map<String, Object> variables = new LinkedHashMap<>();
            activity.variables().forEach((name, v) -> variables.put(name, MessageJson.of(v)));
            return new Activity(
                    activity.instance(),
                    activity.automaton(),
                    activity.before(),
                    activity.after(),
                    taken.map(Trace.Taken::index),
                    place.map(span -> span.file().path()),
                    place.map(span -> span.startPosition().line()),
                    as(Trace.Completed.class, activity.cause())
                            .map(each -> Printable.word(each.completion())),
                    variables,
                    activity.nearest().filter(any -> whyNot).map(WhyNot::of));
        }

        private static <T> Optional<T> as(Class<T> form, Trace.Cause cause) {
            return Optional.of(cause).filter(form::isInstance).map(form::cast);
        }
    }

    /** The transition that came nearest where none was enabled, with all that it asks. */
    private record WhyNot(
            int transition, String move, String file, int line, List<Clause> clauses) {
        static WhyNot of(Refusal refusal) {
            Span place = refusal.transition().span();
            return new WhyNot(
                    refusal.index(),
                    refusal.arrow(),
                    place.file().path(),
                    place.startPosition().line(),
                    refusal.clauses().stream().map(Clause::of).toList());
        }
    }

    /**
     * A condition that had to be true.
     *
     * @param truth {@code true}, {@code false}, {@code undefined} or {@code wrong}
     */
    private record Clause(String text, String truth, Optional<String> because) {
        static Clause of(Refusal.Clause clause) {
            return new Clause(
                    clause.text(),
                    Printable.word(clause.truth()),
                    Optional.of(clause.because()).filter(each -> !each.isEmpty()));
        }
    }

    /** The step that goes wrong, with what was sent before it. */
    private record End(
            int number, Map<String, List<Object>> inputs, Map<String, List<Object>> outputs) {
        static End of(int number, Trace rest) {
            return new End(
                    number,
                    MessageJson.all(RunText.lastInputs(rest)),
                    MessageJson.all(RunText.lastOutputs(rest)));
        }
    }

    @Override
    public void begin(Component component, TraceColumns columns) {
        out.accept(
                text.add(
                        json -> {
                            json.writeStartObject();
                            json.writeStringField("component", component.qualifiedName());
                            json.writeStringField("unit", columns.unit());
                            json.writeArrayFieldStart("steps");
                        }));
    }

    @Override
    public void step(Trace.Step step) {
        out.accept(text.add(json -> json.writePOJO(Step.of(step, whyNot))));
    }

    @Override
    public void end(int steps, Trace rest) {
        out.accept(
                text.add(
                        json -> {
                            json.writeEndArray();
                            if (RunText.endsInError(rest)) {
                                json.writePOJOField("end", End.of(steps, rest));
                            }
                            if (rest.failure().isPresent()) {
                                json.writeStringField("failure", rest.failure().get());
                            }
                            json.writeEndObject();
                        }));
        out.accept("\n");
    }
}
