package arcomat.live;

import arcomat.live.json.JsonText;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.check.WrittenValue;
import arcomat.report.run.CauseText;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Question;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.RecordedSuite;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A run that somebody makes step by step. It is made anew from its beginning each time: so a step
 * back is a letter less, and a branch is another choice.
 *
 * @param letters what goes in, step by step: lines such as {@code front = clear}
 * @param choices which alternative was picked each time that the model left something open
 */
record Run(MainComponent main, List<String> letters, List<Integer> choices) {
    /** Nobody has said yet which alternative is to be taken. */
    private static final class Undecided extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Question question;

        Undecided(Question question) {
            super("undecided");
            this.question = question;
        }
    }

    /** What came of it. */
    private record Outcome(Trace trace, Optional<Question> open, List<String> decisions) {}

    String answer() throws WrongUse {
        Network network = Network.of(main.component(), main.arguments());
        Outcome outcome = run(network);
        return JsonText.object(
                json -> {
                    json.objects("inputs", network.inputs(), Run::input);
                    json.objects("steps", outcome.trace().steps(), Run::step);
                    outcome.trace().failure().ifPresent(reason -> json.field("failure", reason));
                    outcome.open()
                            .ifPresent(
                                    question ->
                                            json.field("open", each -> question(each, question)));
                });
    }

    /** The run as the text of a suite with one test. */
    String suite(String name) throws WrongUse {
        Outcome outcome = run(Network.of(main.component(), main.arguments()));
        List<String> remarks = new ArrayList<>();
        remarks.add("Recorded on the live page.");
        if (!outcome.decisions().isEmpty()) {
            remarks.add("Choices: " + String.join("; ", outcome.decisions()));
        }
        return RecordedSuite.of(name, outcome.trace(), main.arguments(), remarks);
    }

    private Outcome run(Network network) throws WrongUse {
        int[] made = {0};
        Choice choice =
                Choice.ask(
                        question -> {
                            if (made[0] == choices.size()) {
                                throw new Undecided(question);
                            }
                            return choices.get(made[0]++);
                        });
        Interpreter interpreter = new Interpreter(main.component(), main.arguments(), choice);
        List<Letter> read = new ArrayList<>();
        for (String letter : letters) {
            read.add(letter(letter, network));
        }
        List<Trace.Step> steps = new ArrayList<>();
        try {
            Trace rest =
                    Simulation.run(
                            interpreter,
                            read.iterator(),
                            step -> {
                                steps.add(step);
                                return true;
                            });
            return new Outcome(rest.with(steps), Optional.empty(), interpreter.decisions());
        } catch (Undecided open) {
            Trace soFar = new Trace(main.component(), steps, Optional.empty());
            return new Outcome(soFar, Optional.of(open.question), interpreter.decisions());
        }
    }

    private static Letter letter(String written, Network network) throws WrongUse {
        Map<String, Value> messages = new LinkedHashMap<>();
        for (String line : written.isEmpty() ? new String[0] : written.split("\n")) {
            int equals = line.indexOf('=');
            String name = line.substring(0, Math.max(0, equals)).strip();
            String text = line.substring(equals + 1).strip();
            Port port =
                    network.inputs().stream()
                            .filter(each -> each.name().equals(name))
                            .map(Network.External::port)
                            .findFirst()
                            .orElseThrow(() -> new WrongUse("there is no input '" + name + "'"));
            messages.put(name, value(text, port.type()));
        }
        return Letter.of(messages);
    }

    private static Value value(String text, Type type) throws WrongUse {
        return WrittenValue.parse(text, type)
                .orElseThrow(() -> new WrongUse("'" + text + "' is not a value of " + type.name()));
    }

    private static void input(JsonText json, Network.External input) {
        json.field("name", input.name());
        json.field("type", input.port().type().simpleName());
        json.field("total", input.port().total());
        json.field("first", String.valueOf(input.port().type().first()));
        json.strings("values", input.port().type().match(new FewValues()));
    }

    private static void step(JsonText json, Trace.Step step) {
        json.strings("inputs", words(step.inputs()));
        json.strings("outputs", words(step.outputs()));
        json.objects("activities", step.activities(), Run::activity);
    }

    private static void activity(JsonText json, Trace.Activity activity) {
        json.field("instance", activity.instance());
        json.field("automaton", activity.automaton());
        json.field("before", activity.before());
        json.field("after", activity.after());
        json.field("cause", CauseText.of(activity.cause()));
        if (activity.cause() instanceof Trace.Taken taken) {
            json.field("transition", taken.index());
            ModelAnswers.place(json, taken.transition().span());
        }
        json.strings(
                "variables",
                activity.variables().entrySet().stream()
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .toList());
    }

    private static void question(JsonText json, Question question) {
        json.field("instance", question.instance());
        json.field("step", question.step());
        json.strings("alternatives", question.alternatives());
    }

    private static List<String> words(Letter letter) {
        List<String> words = new ArrayList<>();
        letter.messages()
                .forEach(
                        (port, values) -> values.forEach(value -> words.add(port + " = " + value)));
        return words;
    }
}
