package arcomat.analysis.contradiction;

import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Requirements that compare numbers and texts with arbitrary values. */
final class Comparisons {
    private static final List<String> INPUTS =
            List.of("Integer[-2..9]", "Integer", "Long", "Double", "String");

    private Comparisons() {}

    static Promise of(long seed) {
        Random random = new Random(seed);
        String type = INPUTS.get(random.nextInt(INPUTS.size()));
        StringBuilder text = new StringBuilder("package coffee;\ncomponent Compare {\n");
        text.append(random.nextBoolean() ? "port <<total>> in " : "port in ").append(type);
        text.append(" x, in Boolean b, out Integer[0..3] y, out Boolean z;\n");
        for (int i = 0; i < 2; i++) {
            text.append("<<completion = \"output\">> automaton r%d { state s, t;\n".formatted(i));
            text.append("initial s / {%s = --};\n".formatted(i == 0 ? "y" : "z"));
            int count = 1 + random.nextInt(3);
            for (int j = 0; j < count; j++) {
                text.append(random.nextBoolean() ? "s -> t " : "t -> s ");
                text.append(condition(type, random));
                text.append(" / {").append(i == 0 ? "y = " + j : "z = " + (j == 0)).append("};\n");
            }
            text.append("}\n");
        }
        SourceFile file = new SourceFile("coffee/Compare.arc", text + "}\n");
        return Promise.of(
                ReadModels.model(file).component("coffee.Compare").orElseThrow(), List.of());
    }

    private static String condition(String type, Random random) {
        List<String> items = new ArrayList<>();
        String guard = "";
        switch (random.nextInt(6)) {
            case 0 -> items.add("x == " + value(type, random));
            case 1 ->
                    items.add(
                            "x == alt {%s, %s}"
                                    .formatted(value(type, random), value(type, random)));
            case 2 -> guard = "[x != %s]".formatted(value(type, random));
            case 3 -> guard = order(type, random);
            case 4 -> guard = "[%s || x == %s]".formatted(inner(type, random), value(type, random));
            default -> items.add("x == ?");
        }
        if (random.nextInt(3) == 0) {
            items.add("b == " + random.nextBoolean());
        }
        return guard + " {" + String.join(", ", items) + "}";
    }

    private static String inner(String type, Random random) {
        String order = order(type, random);
        return order.substring(1, order.length() - 1);
    }

    private static String order(String type, Random random) {
        String operator =
                type.equals("String") ? "!=" : List.of("<", "<=", ">", ">=").get(random.nextInt(4));
        return "[x %s %s]".formatted(operator, value(type, random));
    }

    private static String value(String type, Random random) {
        int number = random.nextInt(9) - 2;
        return switch (type) {
            case "Double" -> number + ".5";
            case "String" -> "\"" + "abc".substring(0, Math.abs(number) % 4) + "\"";
            case "Long" -> number + "000000000L";
            default -> String.valueOf(number);
        };
    }
}
