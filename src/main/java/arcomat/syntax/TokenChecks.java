package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.List;

final class TokenChecks {
    private TokenChecks() {}

    static List<Diagnostic> check(SourceFile file, List<Token> tokens) {
        return new ArrayList<>();
    }
}
