package arcomat.editor.answer.fact;

import arcomat.pipeline.recheck.ReadModels;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Referent;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The comment {@code /** ... *}{@code /} that stands in front of a declaration. */
final class DocComment {
    private static final String START = "/**";

    private DocComment() {}

    /** Its text without the stars; empty where there is none. */
    static Optional<String> of(Referent referent, ReadModels models) {
        return referent.declaration().flatMap(name -> before(name, models)).map(DocComment::plain);
    }

    private static Optional<Unit.Comment> before(Span name, ReadModels models) {
        List<Unit.Comment> comments =
                models.parsed(name.file().path())
                        .flatMap(parsed -> parsed.readable())
                        .map(Unit::comments)
                        .orElse(List.of());
        return comments.stream()
                .filter(each -> each.text().startsWith(START))
                .filter(each -> each.span().end() <= name.start())
                .reduce((earlier, later) -> later)
                .filter(each -> isOneDeclaration(each.span(), name));
    }

    /** Whether nothing ends or begins in between that could have been meant instead. */
    private static boolean isOneDeclaration(Span comment, Span name) {
        String between = name.file().text().substring(comment.end(), name.start());
        return withoutBrackets(between).chars().noneMatch(letter -> ";{}(,".indexOf(letter) >= 0);
    }

    /** Stereotypes and arguments of types may hold whatever they like. */
    private static String withoutBrackets(String text) {
        StringBuilder left = new StringBuilder();
        int depth = 0;
        for (char letter : text.toCharArray()) {
            depth += letter == '<' ? 1 : 0;
            if (depth == 0) {
                left.append(letter);
            }
            depth -= letter == '>' ? 1 : 0;
        }
        return left.toString();
    }

    private static String plain(Unit.Comment comment) {
        String text = comment.text();
        String inside = text.substring(START.length(), text.length() - 2);
        return Stream.of(inside.split("\r?\n"))
                .map(line -> line.strip().replaceFirst("^\\* ?", ""))
                .collect(Collectors.joining("\n"))
                .strip();
    }
}
