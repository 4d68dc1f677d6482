package mill;

import java.lang.Number;

/** Holds numbers only, one of which is compared with others. */
component Crate<T extends Number & Comparable<T>> {
  port <<sync>> in T content, <<sync>> in int amount;
}
