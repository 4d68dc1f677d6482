package arcomat.lower.statements;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Arbitrary statements over two inputs, three variables and two outputs. */
final class DrawnProgram {
    private final Random random;
    private final List<String> numbers = new ArrayList<>(List.of("a", "b"));
    private final List<String> truths = new ArrayList<>(List.of("c"));
    private int locals;

    private DrawnProgram(Random random) {
        this.random = random;
    }

    static Program of(Random random) {
        return new DrawnProgram(random).sequence(3);
    }

    private Program sequence(int depth) {
        int knownNumbers = numbers.size();
        int knownTruths = truths.size();
        List<Program> programs = new ArrayList<>();
        for (int count = 1 + random.nextInt(4); count > 0; count--) {
            programs.add(statement(depth));
        }
        numbers.subList(knownNumbers, numbers.size()).clear();
        truths.subList(knownTruths, truths.size()).clear();
        return Program.sequence(programs);
    }

    private Program statement(int depth) {
        return switch (random.nextInt(depth > 1 ? 11 : 8)) {
            case 0, 1 -> Program.assign(one(numbers), number(2));
            case 2 -> Program.assign(one(truths), truth(2));
            case 3 -> Program.send("o", number(2));
            case 4 -> random.nextBoolean() ? Program.send("r", truth(2)) : silence();
            case 5 -> Program.changed(one(numbers), number(1), random.nextBoolean());
            case 6 -> Program.stepped(one(numbers), random.nextBoolean());
            case 7 -> local();
            default ->
                    Program.choice(
                            truth(2),
                            sequence(depth - 1),
                            random.nextBoolean()
                                    ? sequence(depth - 1)
                                    : Program.sequence(List.of()));
        };
    }

    private Program silence() {
        return Program.silence(random.nextBoolean() ? "o" : "r", sign());
    }

    private String sign() {
        return random.nextBoolean() ? "--" : "null";
    }

    private Program local() {
        String name = "t" + locals++;
        if (random.nextBoolean()) {
            Program declared =
                    Program.local(random.nextBoolean() ? "int" : "var Integer", name, number(2));
            numbers.add(name);
            return declared;
        }
        Program declared = Program.local("Boolean", name, truth(2));
        truths.add(name);
        return declared;
    }

    private String one(List<String> names) {
        return names.get(random.nextInt(names.size()));
    }

    private Term number(int depth) {
        if (depth == 0 || random.nextInt(3) == 0) {
            return switch (random.nextInt(4)) {
                case 0 -> Term.constant(random.nextInt(4));
                case 1 -> Term.name("p");
                default -> Term.name(one(numbers));
            };
        }
        Term left = number(depth - 1);
        Term right = number(depth - 1);
        return switch (random.nextInt(7)) {
            case 0, 1 -> Term.calculated(left, "+", right, Integer::sum);
            case 2 -> Term.calculated(left, "-", right, (a, b) -> a - b);
            case 3 -> Term.calculated(left, "*", right, (a, b) -> a * b);
            case 4 -> Term.calculated(left, "/", right, (a, b) -> a / b);
            case 5 -> Term.calculated(left, "%", right, (a, b) -> a % b);
            default -> Term.chosen(truth(depth - 1), left, right);
        };
    }

    private Term truth(int depth) {
        if (depth == 0 || random.nextInt(3) == 0) {
            return switch (random.nextInt(5)) {
                case 0 -> Term.constant(random.nextBoolean());
                case 1 -> Term.name("q");
                case 2 ->
                        Term.silence(
                                random.nextBoolean() ? "p" : "q", random.nextBoolean(), sign());
                default -> Term.name(one(truths));
            };
        }
        return switch (random.nextInt(6)) {
            case 0 -> Term.not(truth(depth - 1));
            case 1 -> Term.either(truth(depth - 1), truth(depth - 1));
            case 2 -> Term.both(truth(depth - 1), truth(depth - 1));
            case 3 -> Term.calculated(number(1), "==", number(1), (a, b) -> a.equals(b));
            case 4 -> Term.calculated(number(1), "<", number(1), (a, b) -> a < b);
            default -> Term.calculated(number(1), ">=", number(1), (a, b) -> a >= b);
        };
    }
}
