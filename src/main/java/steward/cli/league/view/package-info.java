/** Commands that show a league: its table, page and games, and how they open it. */
@Internal
package steward.cli.league.view;

import steward.Internal;
