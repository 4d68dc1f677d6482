package arcomat.model;

import java.util.Optional;

/** A configuration parameter; the default is over earlier parameters. */
public record Parameter(String name, Type type, Optional<Expression> initial) {}
