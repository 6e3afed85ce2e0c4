/** Why a bot lost: who led when, how its lost games ended, and its values in lost and won games side by side. */
package steward.contest.loss;
