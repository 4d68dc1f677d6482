package house;

import house.Colours.*;

/** Says which of its keys is pressed. */
component Keys(Integer[0..2] favourite = 1) {
    timing instant;

    Integer[0..2] last = 2;

    port in Boolean key[3], in Colour[2] lamp, shade, out Integer[0..2] pressed;

    <<completion = "ignore">> automaton {
        state only;

        variable Integer[0..9] heard[3] = 0;

        initial only / {heard[2] = 1};

        only [forall k in key: k == --];
        only {key[0] == true} / {pressed = 0, heard[0] = 1};
        only [key[2 - 1] && !key[0]] / {pressed = 1, heard[1] = heard[3 - 1]};
        only [key[2] && forall i in {0..2 - 1}: !key[i] && key[i + 1]] / {pressed = last};
        only [exists c in Colour: c == lamp[0] && c != shade[1]] / {pressed = favourite};
        only [let best = Colour.RED in best == lamp[1] && shade[0] == best];
        only [let sum = heard[0] + heard[1] in sum > 3 && exists n in Set {sum, favourite}: n * n < 3 + n];
    }
}
