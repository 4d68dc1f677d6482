package arcomat.pipeline.compile;

import static org.eclipse.jdt.internal.compiler.parser.TerminalTokens.TokenNameEOF;
import static org.eclipse.jdt.internal.compiler.parser.TerminalTokens.TokenNamePLUS;
import static org.eclipse.jdt.internal.compiler.parser.TerminalTokens.TokenNameStringLiteral;

import org.eclipse.jdt.core.compiler.InvalidInputException;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileConstants;
import org.eclipse.jdt.internal.compiler.parser.Scanner;

/** String literals of generated Java; adjacent ones are one constant to a compiler. */
final class StringConstants {
    private StringConstants() {}

    /** The most bytes that a constant text takes in a class file; of Java, as far as it is. */
    static int longest(String code) {
        Scanner scanner =
                new Scanner(false, false, false, ClassFileConstants.JDK1_6, null, null, true);
        scanner.setSource(code.toCharArray());
        int longest = 0;
        int size = 0;
        try {
            for (int token = 0; token != TokenNameEOF; token = scanner.getNextToken()) {
                if (token == TokenNameStringLiteral) {
                    size +=
                            scanner.getCurrentStringLiteral()
                                    .chars()
                                    .map(StringConstants::bytes)
                                    .sum();
                    longest = Math.max(longest, size);
                } else if (token != TokenNamePLUS) {
                    size = 0;
                }
            }
        } catch (InvalidInputException noJava) {
            return longest; // which the compiler tells
        }
        return longest;
    }

    /** Of a character in the UTF-8 of class files, in which zero takes two. */
    private static int bytes(int character) {
        return character > 0 && character < 0x80 ? 1 : character < 0x800 ? 2 : 3;
    }
}
