package arcomat.benchmarks.data;

import arcomat.benchmarks.measure.Command;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Questions about numbers of 32 bits, beside the solvers that are installed: the question asked
 * again in a warm process, and all of a cold one, against the whole process of a solver.
 */
public final class DataGroup implements Group {
    /** {@code -Dquestions="gaps 20,chain 5"} asks about others. */
    private static final String USUAL =
            "gaps 10,gaps 20,remainders 7,squares 3,factors 1,factors 2,chain 2,chain 8";

    private static final Map<String, List<String>> SOLVERS =
            Map.of("z3", List.of("z3"), "cvc5", List.of("cvc5", "--incremental"));

    private static final int TIMES = 5;
    private static final double MILLION = 1e6;
    private static final String COLD = " cold";

    private final List<DataQuestion> questions = new ArrayList<>();
    private final List<String> solvers = new ArrayList<>();

    public DataGroup() {
        for (String each : System.getProperty("questions", USUAL).split(",")) {
            questions.add(DataQuestions.of(each));
        }
        for (String solver : List.of("z3", "cvc5")) {
            if (Command.answers(solver, "--version")) {
                solvers.add(solver);
            }
        }
    }

    @Override
    public String name() {
        return "data";
    }

    @Override
    public List<String> prepare() {
        return solvers.isEmpty() ? List.of("neither z3 nor cvc5 is installed") : List.of();
    }

    @Override
    public Map<String, Measurement> measure() throws IOException {
        Map<String, Measurement> results = new LinkedHashMap<>();
        try {
            for (DataQuestion question : questions) {
                measure(question, results);
            }
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return results;
    }

    private void measure(DataQuestion question, Map<String, Measurement> results)
            throws IOException, InterruptedException {
        String label = question.label();
        String[] warm = output(ours(question, AskedQuestion.AGAIN)).split(" ");
        require(warm[0].equals("HOLDS"), label + ": " + warm[0]);
        put(label, List.of(Double.parseDouble(warm[1])), results);
        put(label + COLD, times(ours(question, AskedQuestion.ONCE), "HOLDS"), results);
        Path script = Files.createTempFile("question", ".smt2");
        Files.writeString(script, question.script());
        for (String solver : solvers) {
            List<String> command = new ArrayList<>(SOLVERS.get(solver));
            command.add(script.toString());
            put(label + " " + solver, times(command, "unsat"), results);
        }
        Files.delete(script);
    }

    /**
     * @param answer each line of the output
     */
    private static List<Double> times(List<String> command, String answer)
            throws IOException, InterruptedException {
        List<Double> times = new ArrayList<>();
        for (int i = 0; i < TIMES; i++) {
            long start = System.nanoTime();
            String output = output(command);
            times.add((System.nanoTime() - start) / MILLION);
            require(output.lines().allMatch(answer::equals), command + ": " + output);
        }
        return times;
    }

    private static String output(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        require(process.waitFor() == 0, command + ": " + output);
        return output.strip();
    }

    private static void require(boolean so, String message) {
        if (!so) {
            throw new IllegalStateException(message);
        }
    }

    private static void put(String label, List<Double> times, Map<String, Measurement> results) {
        results.put(label, Measurement.of(label, times, "ms"));
    }

    private static List<String> ours(DataQuestion question, String how) {
        return Command.java(
                "2g",
                AskedQuestion.class,
                List.of(how, question.name(), String.valueOf(question.size())));
    }

    @Override
    public List<Goal> goals() {
        List<Goal> goals = new ArrayList<>();
        for (DataQuestion question : questions) {
            String label = question.label();
            for (String solver : solvers) {
                String other = label + " " + solver;
                goals.add(Goal.aim(label + ", of " + solver + "'s process", label, other, 1));
                goals.add(Goal.aim(label + " cold, of " + solver + "'s", label + COLD, other, 1));
            }
        }
        return goals;
    }
}
